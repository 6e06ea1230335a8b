#include "Logic/Geometry/Topology.h"
