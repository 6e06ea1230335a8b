#include "Logic/VtkBridge/PolyDataBridge.h"
