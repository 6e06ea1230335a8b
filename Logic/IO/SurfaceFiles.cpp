#include "Logic/IO/SurfaceFiles.h"
