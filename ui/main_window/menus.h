#pragma once
// The menus: what they say, their keys, and what they are joined to.
#include <QCoreApplication>
#include <QMenuBar>

#include "ui/steps/step_panel.h"

namespace heft {

class MainWindow;

class MenuBuilder {
  Q_DECLARE_TR_FUNCTIONS(MenuBuilder)
 public:
  explicit MenuBuilder(MainWindow* window) : w_(window) {}
  /// Fills the bar; the panels add their own actions afterwards.
  StudioMenus build(QMenuBar* bar);
  /// After the panels have added theirs: the steps, and no empty menus.
  void finish(QMenuBar* bar, const StudioMenus& menus);

 private:
  void buildFile(QMenu* menu);
  void buildEdit(QMenu* menu);
  void buildView(QMenu* menu);
  void buildTools(QMenu* menu);
  void buildHelp(QMenu* menu);
  MainWindow* w_;
};

}  // namespace heft
