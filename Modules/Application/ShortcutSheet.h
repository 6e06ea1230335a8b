#pragma once

class QMainWindow;

namespace falciform {

/// All keys and mouse moves, those of the menus as they are: shown beside the window, closed by Esc.
void showShortcuts(QMainWindow* window);

}  // namespace falciform
