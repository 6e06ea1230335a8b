#include "Logic/Deformation/DeformationLogic.h"
