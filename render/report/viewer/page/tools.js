// Tools as translucent bodies with their edges, each of which moves and can be hidden.

const TOOL_COLOURS = { die: 0x7d8fa6, core: 0xa58a6f, punch: 0x8fa67d, shoe: 0x9a86b0, plate: 0x8b9498 };
const MOST_TRIANGLES_WITH_EDGES = 60000, EDGE_ANGLE = 30;

function toolGeometry(tool) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(tool.vertices, 3));
  geometry.setIndex(new THREE.BufferAttribute(tool.corners, 1));
  return geometry;
}

/** The surface, back faces before front faces so that both show through. */
function toolFaces(geometry, colour, opacity) {
  const flat = geometry.toNonIndexed();
  flat.computeVertexNormals();
  return [THREE.BackSide, THREE.FrontSide].map((side, order) => {
    const material = new THREE.MeshLambertMaterial(
      { color: colour, side: side, transparent: true, opacity: opacity, depthWrite: false });
    const mesh = new THREE.Mesh(flat, material);
    mesh.renderOrder = 10 + order;
    return mesh;
  });
}

/** One tool of a run in a scene. */
class Tool {
  constructor(tool, number) {
    this.name = tool.name; this.number = number; this.shown = tool.shown;
    this.group = new THREE.Group();
    this.group.matrixAutoUpdate = false;
    this.faces = [];
    if (!tool.shown) return;
    const geometry = toolGeometry(tool);
    const colour = TOOL_COLOURS[tool.role.split(" ")[0]] || 0x8b9498;
    this.faces = toolFaces(geometry, colour, 0.25);
    this.group.add(...this.faces);
    if (tool.corners.length / 3 <= MOST_TRIANGLES_WITH_EDGES) {
      this.edges = new THREE.LineSegments(new THREE.EdgesGeometry(geometry, EDGE_ANGLE),
        new THREE.LineBasicMaterial({ color: 0x3a4450, transparent: true, opacity: 0.55, depthWrite: false }));
      this.edges.renderOrder = 12;
      this.group.add(this.edges);
    }
  }

  /** To the pose of a frame: quaternion, then displacement. */
  move(pose) {
    const [w, x, y, z, dx, dy, dz] = pose;
    this.group.matrix.makeRotationFromQuaternion(new THREE.Quaternion(x, y, z, w));
    this.group.matrix.setPosition(dx, dy, dz);
    this.group.matrixWorldNeedsUpdate = true;
  }

  setOpacity(opacity) {
    for (const face of this.faces) {
      face.material.opacity = opacity;
      face.material.depthWrite = opacity >= 1;
    }
  }

  /** `planes`: what is cut away, as three.js takes it. */
  cut(planes) {
    for (const part of [...this.faces, this.edges]) if (part) part.material.clippingPlanes = planes;
  }
}
