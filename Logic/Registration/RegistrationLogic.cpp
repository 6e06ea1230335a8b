#include "Logic/Registration/RegistrationLogic.h"
