#include "Logic/Segmentation/SurfaceImport.h"
