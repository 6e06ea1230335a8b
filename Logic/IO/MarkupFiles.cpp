#include "Logic/IO/MarkupFiles.h"
