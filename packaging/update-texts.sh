#!/bin/sh
# Brings resources/translations up to date with the texts in the sources (tr()). English needs its plurals only; German is
# translated with Qt Linguist. Run it after changing a text; it fails if a German text is missing.
set -eu
cd "$(dirname "$0")/.."
lupdate -silent -locations none -no-ui-lines -pluralonly -I . -source-language en -target-language en app ui \
        -ts resources/translations/heft_en.ts
lupdate -silent -locations none -no-ui-lines -no-obsolete -I . -source-language en -target-language de app ui \
        -ts resources/translations/heft_de.ts
missing=$(grep -c 'type="unfinished"' resources/translations/heft_de.ts || true)
if [ "$missing" -ne 0 ]; then
  echo "$missing German texts are missing in resources/translations/heft_de.ts" >&2
  exit 1
fi
