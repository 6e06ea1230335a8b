#include "Logic/Patches/PatchPaintingLogic.h"
