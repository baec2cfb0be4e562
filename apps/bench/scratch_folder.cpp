#include "scratch_folder.h"

namespace tank_datum::bench {

ScratchFolder::ScratchFolder(const std::string& folder) {
  results::removeStale(folder);
  staging_ = std::make_unique<results::Staging>(folder);
  on_stop_ = std::make_unique<results::OnStop>([this] { staging_->remove(); });
}

ScratchFolder::~ScratchFolder() {
  const results::NoStop hold;
  on_stop_.reset();
  staging_.reset();
}

}  // namespace tank_datum::bench
