#include "Logic/IO/OutputFile.h"
