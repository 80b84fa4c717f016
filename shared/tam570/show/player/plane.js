// A scene in the plane needs no projection.
const camera = null;
const seen = (x, y) => [x, y];
const sizeSeen = (size) => size;
