#include "Logic/IO/CaseFolder.h"
