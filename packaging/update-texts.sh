#!/bin/sh
# Brings resources/translations up to date with the texts in the sources: tr() in ui, say() in core. English needs its plurals only; German is
# translated with Qt Linguist. Run it after changing a text; it fails if a German text or an English plural is missing.
set -eu
cd "$(dirname "$0")/.."
collect() {  # language, options; "lacks Q_OBJECT" is said of say(), which is no member of a Qt class
  language=$1
  shift
  lupdate -silent -locations none -no-ui-lines -I . -tr-function-alias tr+=say,tr+=toSay "$@" -source-language en \
          -target-language "$language" app core ui -ts "resources/translations/heft_$language.ts" 2>&1 |
    grep -v "lacks Q_OBJECT macro" || true
}
collect en -pluralonly -no-obsolete
collect de -no-obsolete
for language in en de; do
  missing=$(grep -c 'type="unfinished"' "resources/translations/heft_$language.ts" || true)
  [ "$missing" -eq 0 ] && continue
  echo "$missing texts are missing in resources/translations/heft_$language.ts" >&2
  exit 1
done
