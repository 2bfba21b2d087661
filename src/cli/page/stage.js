// The body turning in three dimensions: what is drawn of a moment, and how it is lit.

import {
  AmbientLight, BoxGeometry, BufferGeometry, CircleGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight, DoubleSide, EdgesGeometry, Group,
  LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, PerspectiveCamera, Points, PointsMaterial, Quaternion,
  Scene, SphereGeometry, Vector3, WebGLRenderer
} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {Line2} from 'three/addons/lines/Line2.js';
import {LineGeometry} from 'three/addons/lines/LineGeometry.js';
import {LineMaterial} from 'three/addons/lines/LineMaterial.js';
import {CSS2DObject, CSS2DRenderer} from 'three/addons/renderers/CSS2DRenderer.js';

import {element} from './report.js';

const axis_names = ['x', 'y', 'z'];
const axis_paints = ['--axis-x', '--axis-y', '--axis-z'];
const size_of_omega = 1.3;     // the greatest, where the body's longest half side is 1
const size_of_momentum = 1.5;

export class stage {
  constructor(holder, data, path) {
    this.holder = holder;
    this.data = data;
    this.path = path;
    this.paints = [];  // [material, the property of the page that has its colour]
    this.world = new Group();
    this.body = new Group();
    this.world.add(this.body);
    this.scene = new Scene();
    this.scene.add(this.world, new AmbientLight(0xffffff, 1.5));

    const greatest = path.omegas ? Math.max(...path.omegas.map(one => one.length())) : 0;
    this.scale = greatest > 0 && Number.isFinite(greatest) ? size_of_omega / greatest : 0;
    const first = data.j ? new Vector3(...data.j[0]).applyQuaternion(path.attitude(0)) : new Vector3(0, 0, 1);
    this.up = first.normalize();

    this.add_solids();
    this.add_axes();
    if (data.j) this.momentum = this.arrow('--momentum', 'J', .018);
    if (this.scale) {
      this.omega = this.arrow('--polhode', 'ω', .014);
      this.body.add(this.curve(path.curve(x => path.omega(x).multiplyScalar(this.scale)), '--polhode'));
      if (path.attitudes) {
        this.world.add(this.curve(
            path.curve(x => path.omega(x).multiplyScalar(this.scale).applyQuaternion(path.attitude(x))), '--herpolhode'));
      }
      this.add_ellipsoid();
    }

    this.renderer = new WebGLRenderer({antialias: true, alpha: true});
    this.renderer.setPixelRatio(window.devicePixelRatio || 1);
    this.labels = new CSS2DRenderer();
    this.labels.domElement.className = 'labels';
    holder.append(this.renderer.domElement, this.labels.domElement);
    this.camera = new PerspectiveCamera(35, 1, .1, 200);
    this.place_camera(5.8);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.enablePan = false;
    this.controls.minDistance = 1.5;
    this.controls.maxDistance = 60;
    this.controls.addEventListener('change', () => this.render());
    this.follows = false;
    this.moment = 0;
    this.recolour();
    this.resize();
    new ResizeObserver(() => this.resize()).observe(holder);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.recolour());
  }

  paint(material, property) {
    this.paints.push([material, property]);
    return material;
  }

  // A light that goes with the camera, so that no side is ever dark.
  place_camera(distance) {
    const side = new Vector3(Math.abs(this.up.x) < .9 ? 1 : 0, Math.abs(this.up.x) < .9 ? 0 : 1, 0);
    const east = side.cross(this.up).normalize();
    const north = new Vector3().crossVectors(this.up, east);
    this.camera.up.copy(this.up);
    this.camera.position.copy(this.up).multiplyScalar(.42).addScaledVector(east, .75).addScaledVector(north, .5).normalize().multiplyScalar(distance);
    this.camera.lookAt(0, 0, 0);
    if (this.camera.children.length === 0) {
      const lamp = new DirectionalLight(0xffffff, 2.2);
      lamp.position.set(-1.5, 2.5, 2);
      lamp.target.position.set(0, 0, -5);
      this.camera.add(lamp, lamp.target);
      this.scene.add(this.camera);
    }
  }

  principal_frame() {
    const [x, y, z] = this.data.axes.map(one => new Vector3(...one));
    return new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(x, y, z));
  }

  // The solids of which the body is composed, else a box that has its moments.
  add_solids() {
    const add = (geometry, materials) => {
      const mesh = new Mesh(geometry, materials);
      const edges = new LineSegments(new EdgesGeometry(geometry, 25), this.paint(new LineBasicMaterial({transparent: true, opacity: .35}), '--ink'));
      mesh.add(edges);
      this.body.add(mesh);
      return mesh;
    };
    if (this.data.solids) {
      const material = this.paint(new MeshLambertMaterial(), '--solid');
      for (const {shape, half, axis, position} of this.data.solids) {
        const box = () => new BoxGeometry(2 * half[0], 2 * half[1], 2 * half[2]);
        const cylinder = () => {
          const across = half[(axis + 1) % 3];
          const made = new CylinderGeometry(across, across, 2 * half[axis], 48);  // along y
          if (axis === 0) made.rotateZ(Math.PI / 2);
          if (axis === 2) made.rotateX(Math.PI / 2);
          return made;
        };
        const ellipsoid = () => new SphereGeometry(1, 48, 32).scale(...half);
        add(shape === 'box' ? box() : shape === 'cylinder' ? cylinder() : ellipsoid(), material).position.set(...position);
      }
      return;
    }
    const sides = axis_paints.map(property => this.paint(new MeshLambertMaterial(), property));
    const [x, y, z] = this.data.half;
    add(new BoxGeometry(2 * x, 2 * y, 2 * z), [sides[0], sides[0], sides[1], sides[1], sides[2], sides[2]]).quaternion.copy(this.principal_frame());
  }

  label(text, property) {
    const made = element('span', text, 'label');
    made.style.color = `var(${property})`;
    return new CSS2DObject(made);
  }

  add_axes() {
    this.data.axes.forEach((direction, i) => {
      const along = new Vector3(...direction);
      const length = Math.min(1.45, Math.max(.45, this.data.half[i]) + .3);
      const rod = new Mesh(new CylinderGeometry(.008, .008, 2 * length, 8), this.paint(new MeshBasicMaterial(), axis_paints[i]));
      rod.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), along);
      const name = this.label(axis_names[i], axis_paints[i]);
      name.position.copy(along).multiplyScalar(length + .09);
      this.body.add(rod, name);
    });
  }

  // An arrow from the origin, along y until it is pointed.
  arrow(property, text, radius) {
    const material = this.paint(new MeshBasicMaterial(), property);
    const made = new Group();
    made.userData.shaft = new Mesh(new CylinderGeometry(radius, radius, 1, 12).translate(0, .5, 0), material);
    made.userData.head = new Mesh(new ConeGeometry(2.8 * radius, 8 * radius, 16).translate(0, -4 * radius, 0), material);
    made.userData.name = this.label(text, property);
    made.userData.room = 8 * radius;
    made.add(made.userData.shaft, made.userData.head, made.userData.name);
    this.world.add(made);
    return made;
  }
  point(arrow, to) {
    const length = to.length();
    arrow.visible = length > 0;
    if (!arrow.visible) return;
    const {shaft, head, name, room} = arrow.userData;
    arrow.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), to.clone().divideScalar(length));
    shaft.scale.y = Math.max(length - room, 1e-3);
    head.position.y = length;
    name.position.y = length + .1;
  }

  // Through the points; only these where the samples are too few to tell what is between.
  curve(points, property) {
    if (this.path.is_sparse) {
      const dots = new BufferGeometry().setFromPoints(points);
      return new Points(dots, this.paint(new PointsMaterial({size: 6, sizeAttenuation: false}), property));
    }
    const geometry = new LineGeometry().setPositions(points.flatMap(p => [p.x, p.y, p.z]));
    return new Line2(geometry, this.paint(new LineMaterial({linewidth: 2.5}), property));
  }

  // Poinsot's picture: the ellipsoid of the same energy, of semi-axes sqrt(2 H/I_i) along the principal axes, rolls on the plane of
  // all omega with the same J omega = 2 H, and touches it at omega.
  add_ellipsoid() {
    const {axes, moments, omega} = this.data;
    const along = (v, axis) => v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2];
    const parts = axes.map(axis => along(omega[0], axis) * this.scale);
    const twice_energy = parts.reduce((sum, part, i) => sum + moments[i] * part * part, 0);
    const momentum = Math.hypot(...parts.map((part, i) => moments[i] * part));
    const semi_axes = moments.map(moment => Math.sqrt(twice_energy / moment));
    const longest = Math.max(...semi_axes);
    if (!(longest < 50) || !(momentum > 0)) return;
    const skin = this.paint(new MeshLambertMaterial({transparent: true, opacity: .28, side: DoubleSide, depthWrite: false}), '--shell');
    this.shell = new Mesh(new SphereGeometry(1, 64, 40).scale(...semi_axes), skin);
    this.shell.quaternion.copy(this.principal_frame());
    this.shell.visible = false;
    this.body.add(this.shell);
    this.reach = longest;
    if (!this.path.attitudes) return;
    const floor = this.paint(new MeshBasicMaterial({transparent: true, opacity: .14, side: DoubleSide, depthWrite: false}), '--herpolhode');
    const distance = twice_energy / momentum;
    this.plane = new Mesh(new CircleGeometry(1.25 * Math.sqrt(Math.max(size_of_omega ** 2 - distance ** 2, 0)) + .35, 64), floor);
    this.plane.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), this.up);
    this.plane.position.copy(this.up).multiplyScalar(distance);
    this.plane.visible = false;
    this.world.add(this.plane);
  }

  show_ellipsoid(is_shown) {
    this.shell.visible = is_shown;
    if (this.plane) this.plane.visible = is_shown;
    const room = Math.max(5.8, 3.2 * this.reach);
    if (is_shown && this.camera.position.length() < room) this.camera.position.setLength(room);
    this.controls.update();
    this.render();
  }

  recolour() {
    const style = getComputedStyle(document.documentElement);
    for (const [material, property] of this.paints) material.color = new Color(style.getPropertyValue(property).trim());
    this.render();
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.holder;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.labels.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.fov = width < height ? 35 * height / width : 35;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  // x in samples.
  show(x) {
    this.moment = x;
    this.render();
  }

  render() {
    if (!this.renderer || !this.controls) return;
    const attitude = this.path.attitude(this.moment);
    this.body.quaternion.copy(attitude);
    this.world.quaternion.copy(attitude).conjugate();
    if (!this.follows) this.world.quaternion.identity();
    if (this.momentum) {
      const j = this.path.attitudes ? this.up.clone() : this.path.direction(this.moment);
      this.point(this.momentum, j.multiplyScalar(size_of_momentum));
    }
    if (this.omega) this.point(this.omega, this.path.omega(this.moment).multiplyScalar(this.scale).applyQuaternion(attitude));
    this.renderer.render(this.scene, this.camera);
    this.labels.render(this.scene, this.camera);
  }
}
