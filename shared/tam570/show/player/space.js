// A scene in space, seen from the direction of an azimuth and an elevation, without perspective.
const camera = {azimuth: 0, elevation: 0};
function seen(x, y, z, flat) {
  if (flat) return [x, y];
  const ca = Math.cos(camera.azimuth), sa = Math.sin(camera.azimuth);
  const ce = Math.cos(camera.elevation), se = Math.sin(camera.elevation);
  return [ca * y - sa * x, ce * z - se * (ca * x + sa * y)];
}
