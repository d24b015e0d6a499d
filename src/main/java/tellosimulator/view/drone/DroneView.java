package tellosimulator.view.drone;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.paint.Color;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.MeshView;
import javafx.scene.shape.TriangleMesh;
import javafx.scene.transform.Affine;
import javafx.scene.transform.Rotate;
import javafx.scene.transform.Translate;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Mesh;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.drone.DroneParts;
import tellosimulator.scenery.drone.PropellerSpin;
import tellosimulator.scenery.drone.StatusLight;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxFrames;
import tellosimulator.view.FxMeshes;
import tellosimulator.view.FxTextures;

/**
 * A Tello in the 3D scene, in real size: metres, in the room frame. It follows its model's pose;
 * {@link #advance} turns its propellers and lets its light blink. For the JavaFX thread.
 */
public final class DroneView extends Group {

  private final FxDroneModel model;
  private final DroneParts parts;
  private final PropellerSpin spin = new PropellerSpin();
  private final FxTextures textures = new FxTextures();
  private final Map<Mesh, TriangleMesh> meshes = new HashMap<>();
  private final Map<Part, PhongMaterial> materials = new HashMap<>();
  private final Affine pose = new Affine();
  private final MeshView body = new MeshView();
  private final MeshView light = new MeshView();
  private final List<MeshView> propellers = new ArrayList<>();
  private final List<Rotate> turns = new ArrayList<>();
  private double lastSeconds = Double.NaN;

  public DroneView(FxDroneModel model) {
    this.model = model;
    parts = new DroneParts(model.livery());
    initializeSelf();
    initializeParts();
    layoutParts();
    setupBindings();
  }

  /** The node that must look equally bright from everywhere, whatever light falls on it. */
  public Node lamp() {
    return light;
  }

  /** Where it is, room frame [m]. */
  public Vec3 position() {
    return model.poseProperty().get().position();
  }

  /** Moves on what moves by itself, to the moment of the newest snapshot. */
  public void advance() {
    DroneState state = model.snapshotProperty().get().state();
    double seconds = state.time().seconds();
    double passed = Double.isNaN(lastSeconds) ? 0 : Math.max(0, seconds - lastSeconds);
    lastSeconds = seconds;
    if (spin.advance(PropellerSpin.wanted(state.phase(), state.motion()), passed)) {
      turnPropellers();
    }
    show(light, parts.lamp(StatusLight.seen(model.pictured())));
  }

  private void initializeSelf() {
    setId("drone-" + model.number());
    setMouseTransparent(true);
    getTransforms().add(pose);
  }

  private void initializeParts() {
    show(body, parts.body());
    show(light, parts.lamp(StatusLight.DARK));
    for (Vec3 middle : parts.propellers()) {
      Rotate turn = new Rotate(0, Rotate.Z_AXIS);
      MeshView propeller = new MeshView();
      propeller.getTransforms().addAll(new Translate(middle.x(), middle.y(), middle.z()), turn);
      turns.add(turn);
      propellers.add(propeller);
    }
    turnPropellers();
  }

  private void layoutParts() {
    getChildren().addAll(body, light);
    getChildren().addAll(propellers);
  }

  private void setupBindings() {
    model.poseProperty().subscribe(newPose -> FxFrames.place(pose, newPose));
  }

  private void turnPropellers() {
    for (int i = 0; i < propellers.size(); i++) {
      show(propellers.get(i), parts.propeller(i, spin.blurred()));
      turns.get(i).setAngle(Math.toDegrees(parts.heading(i, spin.angle())));
    }
  }

  private void show(MeshView view, Part part) {
    PhongMaterial material = materials.computeIfAbsent(part, this::material);
    if (view.getMaterial() != material) {
      view.setMaterial(material);
      view.setMesh(meshes.computeIfAbsent(part.mesh(), FxMeshes::of));
    }
  }

  private PhongMaterial material(Part part) {
    PhongMaterial material = new PhongMaterial();
    material.setDiffuseMap(textures.image(part.texture()));
    if (part.finish() == Finish.LIT) {
      material.setSpecularColor(Color.gray(0.35));
      material.setSpecularPower(28);
    }
    return material;
  }
}
