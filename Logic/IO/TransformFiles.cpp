#include "Logic/IO/TransformFiles.h"
