#pragma once
#include "Logic/Core/Draws.h"  // it moved there, for all rooms
