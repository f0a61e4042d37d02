#include "ui/theme/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "ui/theme/theme.h"

namespace heft {

QPixmap iconPixmap(const QString& name, int size, const QColor& colour, const QColor& ground, qreal devicePixelRatio) {
  // Panels are often built anew, and drawing an icon takes a millisecond.
  const QString key =
      QStringLiteral("icon %1 %2 %3 %4 %5").arg(name).arg(size).arg(colour.name(), ground.name()).arg(devicePixelRatio);
  QPixmap pixmap;
  if (QPixmapCache::find(key, &pixmap)) return pixmap;
  pixmap = QPixmap(QSize(size, size) * devicePixelRatio);
  pixmap.setDevicePixelRatio(devicePixelRatio);
  pixmap.fill(Qt::transparent);
  QFile file(":/icons/" + name + ".svg");
  if (!file.open(QIODevice::ReadOnly)) return pixmap;
  QByteArray svg = file.readAll();
  svg.replace("currentColor", colour.name().toLatin1());
  svg.replace("Canvas", ground.name().toLatin1());
  QSvgRenderer renderer(svg);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  renderer.render(&painter, QRectF(0, 0, size, size));
  painter.end();
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

QIcon themedIcon(const QString& name, int size) {
  const Theme& t = theme();
  QIcon icon;
  for (const qreal ratio : {1.0, 2.0}) {
    icon.addPixmap(iconPixmap(name, size, t.text2, t.panel, ratio), QIcon::Normal);
    icon.addPixmap(iconPixmap(name, size, t.text, t.panel, ratio), QIcon::Active);
    icon.addPixmap(iconPixmap(name, size, t.fieldEdge, t.panel, ratio), QIcon::Disabled);
  }
  return icon;
}

QIcon applicationIcon() {
  QIcon icon;
  const Theme& t = themeOf(ThemeKind::light);
  for (const int size : {16, 32, 48, 128}) icon.addPixmap(iconPixmap("heft", size, t.accent, t.panel, 1.0));
  return icon;
}

}  // namespace heft
