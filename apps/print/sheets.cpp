#include "print/sheets.h"

#include "results/file_calls.h"

namespace tank_datum {

int sheetsOf(const std::string& pdf) {
  const std::string content = results::contentOf(pdf), mark = "/Type /Page";
  int sheets = 0;
  for (std::size_t at = 0; (at = content.find(mark, at)) != std::string::npos; at += mark.size()) {
    sheets += content.compare(at + mark.size(), 1, "s") != 0 ? 1 : 0;  // not the list of them, /Pages
  }
  return sheets;
}

std::string shrunk(const std::string& page, const std::string& share) {
  std::string smaller = page;
  const auto at = smaller.find("</head>");
  if (at != std::string::npos) smaller.insert(at, "<style>@media print { body { zoom: " + share + "; } }</style>\n");
  return smaller;
}

}  // namespace tank_datum
