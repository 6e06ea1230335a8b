#include "Logic/IO/ResultFiles.h"
