#include "Logic/Registration/SurfaceRegistration.h"
