#pragma once

#include <pcl/filters/filter_indices.h>
#include <pcl/point_types.h>
#include <pcl/search/search.h>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/datum.h"

namespace TANK_DATUM_API tank_datum {

/// The chain as a filter of PCL: keeps a cloud's edge points, those where a tank's shell meets its foundation, and has
/// the datum made from them.
///
/// It obeys pcl::FilterIndices: points come out in the order of the indices given, not finite ones are always removed,
/// and a scan without a usable datum has no edge points (getDatum().status says why). Instantiated for PointXYZ,
/// PointXYZI, PointXYZRGB and PointNormal; for other point types with x, y and z include
/// tank_datum/pcl/impl/datum_filter.hpp.
///
/// filter() throws Error (Option) for refused options, for an index that the cloud does not have, and for a search
/// method that finds too few neighbours; the outputs are empty then and getDatum() says NotRun.
template <typename PointT>
class DatumFilter : public pcl::FilterIndices<PointT> {
 public:
  using Base = pcl::FilterIndices<PointT>;
  using PointCloud = typename Base::PointCloud;
  using PointCloudConstPtr = typename Base::PointCloudConstPtr;
  using Ptr = pcl::shared_ptr<DatumFilter<PointT>>;
  using ConstPtr = pcl::shared_ptr<const DatumFilter<PointT>>;
  using SearcherPtr = typename pcl::search::Search<PointT>::Ptr;

  /// @param extract_removed_indices  whether getRemovedIndices() is wanted
  explicit DatumFilter(bool extract_removed_indices = false);

  /// Forgets the last cloud's datum, and what a search knows of this cloud: a cloud that is given again may have been
  /// filled anew.
  void setInputCloud(const PointCloudConstPtr& cloud) override;

  void setOptions(const DatumOptions& options) { options_ = options; }
  const DatumOptions& getOptions() const { return options_; }

  /// Neighbours are asked of this search, not of options.normals.search. It is given the input cloud unless it already
  /// holds it, whole or by the same indices; where setInputCloud gives a cloud that the filter's search holds, it is
  /// given it again. The datum is the same as without it. A ring that is thinned (options.crop.search_points) is asked
  /// for the more neighbours the thinner it is. Null: the chain's own.
  void setSearchMethod(const SearcherPtr& search) {
    if (search != search_) search_is_old_ = false;
    search_ = search;
  }
  SearcherPtr getSearchMethod() const { return search_; }

  /// Whether the cloud's own normals are used, where finite and not zero, instead of estimated ones.
  /// @throws Error (Option) when the point type has none
  void setUseCloudNormals(bool use);
  bool getUseCloudNormals() const { return use_cloud_normals_; }

  /// What is told of a run: the name of each stage as it begins, and in it how many of the scan's points are read.
  using Progress = std::function<void(const char* stage, std::uint64_t points, std::uint64_t of)>;

  /// An exception that it throws cancels the run and leaves filter(); the outputs are empty then and getDatum() says
  /// NotRun. It is heard where stages begin and while points are read. Empty: nobody is told.
  void setProgress(Progress progress) { progress_ = std::move(progress); }

  /// The whole result of the last run; relative to its `origin`.
  const Datum& getDatum() const { return datum_; }

 protected:
  using Base::extract_removed_indices_;
  using Base::indices_;
  using Base::input_;
  using Base::keep_organized_;
  using Base::negative_;
  using Base::removed_indices_;

  void applyFilter(PointCloud& output) override;
  void applyFilter(pcl::Indices& indices) override;

 private:
  /// The input's points that are asked for, each once.
  pcl::IndicesPtr selected() const;
  void runOn(const pcl::IndicesPtr& selection, std::vector<bool>& is_edge);
  Normals normalsOf(const Points& points, const pcl::Indices& chosen, const NormalOptions& options, int threads);
  void prepareSearch();

  DatumOptions options_;
  SearcherPtr search_;
  bool search_is_old_ = false;  ///< made from what the input cloud was before it was set
  bool use_cloud_normals_ = false;
  Progress progress_;
  Datum datum_;
};

extern template class TANK_DATUM_API_CLASS DatumFilter<pcl::PointXYZ>;
extern template class TANK_DATUM_API_CLASS DatumFilter<pcl::PointXYZI>;
extern template class TANK_DATUM_API_CLASS DatumFilter<pcl::PointXYZRGB>;
extern template class TANK_DATUM_API_CLASS DatumFilter<pcl::PointNormal>;

}  // namespace tank_datum
