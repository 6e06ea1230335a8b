#include "Logic/Acquisition/SyntheticLiver.h"
