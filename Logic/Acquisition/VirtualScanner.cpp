#include "Logic/Acquisition/VirtualScanner.h"
