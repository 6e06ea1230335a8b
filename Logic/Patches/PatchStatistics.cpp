#include "Logic/Patches/PatchStatistics.h"
