#include "print/pictured_page.h"

#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

const std::string kBefore = "<template id=\"licences\">";
const std::string kOpening = "<script type=\"application/json\" id=\"data-view\">", kClosing = "</script>\n";

std::string withoutPicture(std::string page) {
  const auto from = page.find(kOpening);
  if (from != std::string::npos) page.erase(from, page.find(kClosing, from) + kClosing.size() - from);
  return page;
}

}  // namespace

std::string withPicture(const std::string& page, const std::string& picture) {
  std::string pictured = withoutPicture(page);
  const auto at = pictured.find(kBefore);
  if (at == std::string::npos) {
    throw Error(Error::Kind::File, "report", "report.html", "no page of this version", "one that tank_datum wrote");
  }
  return pictured.insert(at, kOpening + '"' + picture + '"' + kClosing);
}

}  // namespace tank_datum
