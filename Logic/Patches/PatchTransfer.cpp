#include "Logic/Patches/PatchTransfer.h"
