#include "Logic/Segmentation/SegmentationImportLogic.h"
