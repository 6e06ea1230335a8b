#include "Logic/Geometry/Measures.h"
