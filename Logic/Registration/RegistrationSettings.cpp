#include "Logic/Registration/RegistrationSettings.h"
