#pragma once
#include "Logic/Geometry/RasterMesh.h"  // moved: files are read as rasters too
