#include "Logic/Deformation/DistanceMapping.h"
