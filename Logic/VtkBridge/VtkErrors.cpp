#include "Logic/VtkBridge/VtkErrors.h"
