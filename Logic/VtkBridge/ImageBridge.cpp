#include "Logic/VtkBridge/ImageBridge.h"
