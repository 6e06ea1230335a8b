#include "Widgets/Jobs/Log.h"
