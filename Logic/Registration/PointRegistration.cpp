#include "Logic/Registration/PointRegistration.h"
