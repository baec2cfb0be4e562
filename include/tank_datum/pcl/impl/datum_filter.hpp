#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/type_traits.h>

#include <optional>
#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/impl/pcl_base.hpp>
#include <string>
#include <utility>

#include "tank_datum/core/error.h"
#include "tank_datum/pcl/datum_filter.h"
#include "tank_datum/pcl/pcl_stages.h"

namespace TANK_DATUM_API tank_datum {

template <typename PointT>
DatumFilter<PointT>::DatumFilter(bool extract_removed_indices) : Base(extract_removed_indices) {
  this->filter_name_ = "DatumFilter";
}

template <typename PointT>
void DatumFilter<PointT>::setInputCloud(const PointCloudConstPtr& cloud) {
  Base::setInputCloud(cloud);
  datum_ = Datum();
  removed_indices_ = std::make_shared<pcl::Indices>();
  search_is_old_ = search_is_old_ || (search_ && search_->getInputCloud() == cloud);
}

template <typename PointT>
void DatumFilter<PointT>::setUseCloudNormals(bool use) {
  if (use && !pcl::traits::has_normal<PointT>::value) {
    throw Error(Error::Kind::Option, "filter", "use_cloud_normals", "true", "a point type that has normals");
  }
  use_cloud_normals_ = use;
}

template <typename PointT>
void DatumFilter<PointT>::applyFilter(PointCloud& output) {
  output.clear();
  if (keep_organized_) extract_removed_indices_ = true;  // as the base would, which warns on stderr
  Base::applyFilter(output);
  if (!keep_organized_) output.is_dense = true;  // the base copies the input's flag, and only finite points are kept
}

template <typename PointT>
void DatumFilter<PointT>::applyFilter(pcl::Indices& indices) {
  datum_ = Datum();
  pcl::Indices kept;                                    // `indices` may be the input's own
  removed_indices_ = std::make_shared<pcl::Indices>();  // a new one: the caller may keep the last run's
  std::vector<bool> is_edge(input_->size(), false);
  try {
    runOn(selected(), is_edge);
  } catch (...) {
    if (&indices != indices_.get()) indices.clear();  // the input's own are not lost
    throw;
  }
  for (const pcl::index_t i : *indices_) {
    const auto at = static_cast<std::size_t>(i);
    if (pcl::isXYZFinite((*input_)[at]) && is_edge[at] != negative_) {
      kept.push_back(i);
    } else if (extract_removed_indices_) {
      removed_indices_->push_back(i);
    }
  }
  indices = std::move(kept);
}

template <typename PointT>
pcl::IndicesPtr DatumFilter<PointT>::selected() const {
  auto selection = std::make_shared<pcl::Indices>();
  std::vector<bool> taken(input_->size(), false);
  requireWithin("filter", "index", *indices_, input_->size());
  for (const pcl::index_t i : *indices_) {
    const auto at = static_cast<std::size_t>(i);
    if (!taken[at]) selection->push_back(i);
    taken[at] = true;
  }
  return selection;
}

template <typename PointT>
void DatumFilter<PointT>::runOn(const pcl::IndicesPtr& selection, std::vector<bool>& is_edge) {
  Scan scan = scanOf<PointT>(input_, selection);
  pcl::Indices finite;
  for (const pcl::index_t i : *selection) {
    if (pcl::isXYZFinite((*input_)[static_cast<std::size_t>(i)])) finite.push_back(i);
  }
  std::optional<Scan> turned;  // the same points upright (options.level)
  const auto sources = [&](const Points& points) {
    pcl::Indices found;
    for (const std::size_t row : rowsOf(points, turned ? *turned : scan)) found.push_back(finite[row]);
    return found;
  };
  Callbacks callbacks;
  if (search_ || use_cloud_normals_) {
    callbacks.normals = [&](const Points& points, const NormalOptions& options, int threads) {
      return normalsOf(points, sources(points), options, threads);
    };
  }
  callbacks.turned = [&](const Scan& upright) { turned = upright; };
  const char* stage = "";
  if (progress_) {
    callbacks.stage = [&](const char* begun) { progress_(stage = begun, 0, scan.size()); };
    scan.setProgress([&](std::uint64_t read) { progress_(stage, read, scan.size()); });
  }
  datum_ = extractDatum(scan, options_, callbacks);
  if (!datum_.usable()) return;
  for (const pcl::index_t i : sources(datum_.edge_points)) is_edge[static_cast<std::size_t>(i)] = true;
}

template <typename PointT>
Normals DatumFilter<PointT>::normalsOf(const Points& points, const pcl::Indices& chosen, const NormalOptions& options,
                                       int threads) {
  Normals normals;
  if (search_) {
    prepareSearch();
    auto neighbours = findNeighbours(*search_, *input_, chosen, options.k, threads);
    normals = fitNormals(points, std::move(neighbours), options.k, threads);
  } else {
    normals = estimateNormals(points, options, threads);
  }
  if constexpr (pcl::traits::has_normal<PointT>::value) {
    for (std::size_t i = 0; use_cloud_normals_ && i < chosen.size(); ++i) {
      const Eigen::Vector3f n = (*input_)[static_cast<std::size_t>(chosen[i])].getNormalVector3fMap();
      if (n.allFinite() && !n.isZero(0.0F)) normals.normals[i] = n.stableNormalized();
    }
  }
  return normals;
}

template <typename PointT>
void DatumFilter<PointT>::prepareSearch() {
  const auto covered = search_->getIndices();
  const bool holds_all = !covered || covered == indices_ || *covered == *indices_;
  if (search_is_old_ || search_->getInputCloud() != input_ || !holds_all) search_->setInputCloud(input_);
  search_is_old_ = false;
}

}  // namespace tank_datum
