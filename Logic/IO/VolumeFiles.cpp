#include "Logic/IO/VolumeFiles.h"
