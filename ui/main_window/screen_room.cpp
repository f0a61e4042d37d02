#include "ui/main_window/screen_room.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>
#include <algorithm>

namespace heft {
namespace {

/// [px] What a window manager's frame takes, before it is known: title bar and edges.
constexpr QSize kFrame(12, 44);

}  // namespace

QSize roomOnScreen() {
  const QScreen* screen = QGuiApplication::primaryScreen();
  return screen ? screen->availableSize() - kFrame : QSize(1440, 900);
}

void keepOnScreen(QWidget* window) {
  const QScreen* on = window->screen();
  if (!on || window->isMaximized() || window->isFullScreen() || (window->windowFlags() & Qt::FramelessWindowHint))
    return;
  const QRect room = on->availableGeometry();
  const QSize frame = window->frameGeometry().size() - window->size();
  window->resize(window->size().boundedTo(room.size() - frame));
  const QRect now = window->frameGeometry();
  window->move(std::clamp(now.left(), room.left(), std::max(room.left(), room.right() + 1 - now.width())),
               std::clamp(now.top(), room.top(), std::max(room.top(), room.bottom() + 1 - now.height())));
}

}  // namespace heft
