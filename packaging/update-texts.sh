#!/bin/sh
# Brings resources/translations up to date with the texts in the sources: tr() in ui, say() in core. English needs its plurals only; German is
# translated with Qt Linguist. Run it after changing a text; it fails if a German text is missing.
set -eu
cd "$(dirname "$0")/.."
collect() {  # language, options; "lacks Q_OBJECT" is said of say(), which is no member of a Qt class
  language=$1
  shift
  lupdate -silent -locations none -no-ui-lines -I . -tr-function-alias tr+=say,tr+=toSay "$@" -source-language en \
          -target-language "$language" app core ui -ts "resources/translations/heft_$language.ts" 2>&1 |
    grep -v "lacks Q_OBJECT macro" || true
}
collect en -pluralonly
collect de -no-obsolete
missing=$(grep -c 'type="unfinished"' resources/translations/heft_de.ts || true)
if [ "$missing" -ne 0 ]; then
  echo "$missing German texts are missing in resources/translations/heft_de.ts" >&2
  exit 1
fi
