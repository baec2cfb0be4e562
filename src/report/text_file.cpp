#include "report/text_file.h"

#include <cerrno>
#include <fstream>

#include "core/refusal.h"

namespace tank_datum {

void writeTextFile(const std::string& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw refusedBySystem("report", path, path, errno, "a writable folder with room for the results");
}

}  // namespace tank_datum
