#include "terminal.h"

#include <langinfo.h>
#include <locale.h>
#include <unistd.h>

#include <string>

namespace tank_datum {

bool showsBlocks() {
  if (!isatty(STDOUT_FILENO)) return false;
  const locale_t locale = newlocale(LC_CTYPE_MASK, "", nullptr);
  if (locale == nullptr) return false;
  const bool utf8 = std::string(nl_langinfo_l(CODESET, locale)) == "UTF-8";
  freelocale(locale);
  return utf8;
}

}  // namespace tank_datum
