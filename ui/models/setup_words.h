#pragma once
// The entries of a setup file in words: as in the dialog Robot and sensor and in the suggestions of the reality check.
#include <QString>
#include <QStringList>
#include <QVector>

namespace heft {

struct SetupAnswer {
  QString inFile;  ///< "opposite"; empty where the file holds numbers.
  QString words;   ///< "opposite to the force"
};

struct SetupWords {
  QString title;                 ///< "Torque sign"
  QString tip;                   ///< What is asked for.
  QVector<SetupAnswer> answers;  ///< The plain form first; none where any number or unit can stand.

  QStringList choices() const;  ///< The answers' words.
};

/// Of the entry `key`, such as "torque_sign"; the key itself as title if the dialog has no such field.
SetupWords setupWords(const QString& key);

/// What the file holds in words: "opposite to the force" for "opposite"; itself where it is no answer of this entry.
QString setupAnswer(const QString& key, const QString& inFile);

}  // namespace heft
