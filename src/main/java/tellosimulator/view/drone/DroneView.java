package tellosimulator.view.drone;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.paint.Color;
import javafx.scene.paint.Material;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.CullFace;
import javafx.scene.shape.Mesh;
import javafx.scene.shape.MeshView;
import javafx.scene.shape.Sphere;
import javafx.scene.transform.Affine;
import javafx.scene.transform.Rotate;
import javafx.scene.transform.Translate;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxFrames;

/**
 * A Tello in the 3D scene, in real size: metres, in the room frame. It follows its model's pose;
 * {@link #advance} turns its propellers and lets its light blink. For the JavaFX thread.
 */
public final class DroneView extends Group {

  /** Where the status light sits beside the lens. Assumed: by eye, from pictures. */
  private static final Vec3 LIGHT = new Vec3(0.0488, 0.0088, 0.0205);

  private final FxDroneModel model;
  private final PropellerSpin spin = new PropellerSpin();
  private final Affine pose = new Affine();
  private final MeshView body = new MeshView();
  private final Sphere light = new Sphere(0.0021, 8);
  private final List<MeshView> propellers = new ArrayList<>();
  private final List<Rotate> turns = new ArrayList<>();
  private final Map<StatusLight, Material> lights = new EnumMap<>(StatusLight.class);
  private Looks looks;
  private boolean blurred;
  private double lastSeconds = Double.NaN;

  /** What the propellers are made of, slow and fast. */
  private record Looks(
      Material material, Mesh clockwise, Mesh counterClockwise, Material discMaterial, Mesh disc) {}

  public DroneView(FxDroneModel model) {
    this.model = model;
    initializeSelf();
    initializeParts();
    layoutParts();
    setupBindings();
  }

  /** The node that must look equally bright from everywhere, whatever light falls on it. */
  public Node lamp() {
    return light;
  }

  /**
   * Moves on what moves by itself.
   *
   * @param nanos the time of the picture, for the light [ns]
   */
  public void advance(long nanos) {
    DroneState state = model.snapshotProperty().get().state();
    double seconds = state.time().seconds();
    double passed = Double.isNaN(lastSeconds) ? 0 : Math.max(0, seconds - lastSeconds);
    lastSeconds = seconds;
    if (spin.advance(PropellerSpin.wanted(state.phase(), state.motion()), passed)) {
      turnPropellers();
    }
    StatusLight shown =
        StatusLight.of(
            state.phase(),
            state.energy().battery().percent(),
            model.operatorProperty().get().isPresent());
    Material material = lights.get(shown.lit(nanos / 1e9) ? shown : StatusLight.DARK);
    if (light.getMaterial() != material) {
      light.setMaterial(material);
    }
  }

  private void initializeSelf() {
    setId("drone-" + model.number());
    setMouseTransparent(true);
    getTransforms().add(pose);
  }

  private void initializeParts() {
    PhongMaterial material = new PhongMaterial();
    material.setDiffuseMap(Palette.picture(DroneColors.cover(model.number())));
    material.setSpecularColor(Color.gray(0.35));
    material.setSpecularPower(28);
    body.setMesh(BodyMesh.create());
    body.setMaterial(material);
    PhongMaterial discMaterial = new PhongMaterial();
    discMaterial.setDiffuseMap(PropellerDisc.picture());
    looks =
        new Looks(
            material,
            PropellerMesh.create(true),
            PropellerMesh.create(false),
            discMaterial,
            PropellerDisc.create());
    for (StatusLight shown : StatusLight.values()) {
      boolean dark = shown == StatusLight.DARK;
      lights.put(shown, new PhongMaterial(dark ? Color.gray(0.25) : shown.color()));
    }
    light.setMaterial(lights.get(StatusLight.DARK));
  }

  private void layoutParts() {
    light.getTransforms().add(new Translate(LIGHT.x(), LIGHT.y(), LIGHT.z()));
    getChildren().addAll(body, light);
    for (Vec3 middle : BodyMesh.propellers()) {
      Rotate turn = new Rotate(35 * (turns.size() + 1), Rotate.Z_AXIS);
      MeshView propeller = new MeshView();
      propeller.setCullFace(CullFace.NONE);
      propeller.getTransforms().addAll(new Translate(middle.x(), middle.y(), middle.z()), turn);
      turns.add(turn);
      propellers.add(propeller);
    }
    getChildren().addAll(propellers);
    dressPropellers();
  }

  private void setupBindings() {
    model.poseProperty().subscribe(newPose -> FxFrames.place(pose, newPose));
  }

  private void turnPropellers() {
    double degrees = Math.toDegrees(spin.angle());
    for (int i = 0; i < propellers.size(); i++) {
      turns.get(i).setAngle(clockwise(i) ? -degrees : degrees);
    }
    if (blurred != spin.blurred()) {
      blurred = spin.blurred();
      dressPropellers();
    }
  }

  private void dressPropellers() {
    for (int i = 0; i < propellers.size(); i++) {
      MeshView propeller = propellers.get(i);
      Mesh blades = clockwise(i) ? looks.clockwise : looks.counterClockwise;
      propeller.setMesh(blurred ? looks.disc : blades);
      propeller.setMaterial(blurred ? looks.discMaterial : looks.material);
    }
  }

  /** Front right and back left. Documented: parts list of the Tello; the others turn against it. */
  private static boolean clockwise(int propeller) {
    return propeller == 1 || propeller == 2;
  }
}
