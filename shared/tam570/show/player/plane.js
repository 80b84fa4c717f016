// A scene in the plane is seen as it is.
const camera = null;
const seen = (x, y) => [x, y];
const sizeSeen = (size) => size;
