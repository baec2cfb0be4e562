#!/usr/bin/env bash
# Run by cibuildwheel in its image (AlmaLinux) before the first wheel: what a build needs. Of PCL the parts that are used, and
# those that their headers need.
set -euo pipefail
pcl=1.13.1
sleef=3.5.1
dnf install -y -q epel-release
dnf install -y -q cmake ninja-build npm boost-devel eigen3-devel flann-devel lz4-devel openssl-devel json-devel cli11-devel \
  fast_float-devel liblzf-devel xxhash-devel tomlplusplus-devel
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
curl -fsSL "https://github.com/PointCloudLibrary/pcl/archive/refs/tags/pcl-$pcl.tar.gz" | tar -xz -C "$work"
parts=()
for part in apps examples geometry global_tests gpu io keypoints ml outofcore people recognition registration segmentation \
  simulation stereo surface tools tracking visualization; do
  parts+=("-DBUILD_$part=OFF")
done
cmake -S "$work/pcl-pcl-$pcl" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPCL_ENABLE_MARCHNATIVE=OFF \
  -DPCL_ENABLE_SSE=OFF -DPCL_ONLY_CORE_POINT_TYPES=ON -DWITH_VTK=OFF -DWITH_QT=OFF "${parts[@]}"
cmake --build "$work/build"
cmake --install "$work/build"
curl -fsSL "https://github.com/shibatch/sleef/archive/refs/tags/$sleef.tar.gz" | tar -xz -C "$work"
cmake -S "$work/sleef-$sleef" -B "$work/build-sleef" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON \
  -DBUILD_TESTS=OFF -DBUILD_DFT=OFF
cmake --build "$work/build-sleef"
cmake --install "$work/build-sleef"
ldconfig
mkdir -p /usr/share/nodejs/d3/dist
(cd "$work" && tar -xzf "$(npm pack --silent d3@7)" && cp package/dist/d3.min.js /usr/share/nodejs/d3/dist/)
