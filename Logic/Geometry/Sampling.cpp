#include "Logic/Geometry/Sampling.h"
