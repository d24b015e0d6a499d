package tellosimulator.view.world;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import javafx.geometry.Point3D;
import javafx.scene.AmbientLight;
import javafx.scene.DepthTest;
import javafx.scene.DirectionalLight;
import javafx.scene.Group;
import javafx.scene.LightBase;
import javafx.scene.paint.Color;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Lights;
import tellosimulator.scenery.mesh.MeshBatch;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.view.fx.FxFrames;
import tellosimulator.view.fx.FxTextures;

/**
 * Represents a scene as JavaFX nodes in the room frame. When a new scene is shown, only the nodes
 * that differ from the previous scene change. The groups are in drawing order; the nodes of a group
 * have the same lights and blending. Confined to the JavaFX thread.
 */
final class SceneNodes extends Group {

  /**
   * Height of decals above an obstacle [m]. Decided: prevents flickering up to a distance of 10 m.
   */
  private static final double DECAL_OFFSET = 0.002;

  /** Distance below which drones are always drawn [m]. Decided: several times their size. */
  private static final double NEARBY = 1;

  /**
   * Cosine of the maximum angle from the middle of the view at which drones are drawn. Decided:
   * enough for the aspect ratio of any window.
   */
  private static final double WIDEST = Math.cos(Math.toRadians(58));

  private final FxParts parts = new FxParts();
  private final InstanceGroup room = new InstanceGroup("room", parts, DepthTest.DISABLE);
  private final InstanceGroup ground = new InstanceGroup("ground", parts, DepthTest.DISABLE);
  private final InstanceGroup obstacles = new InstanceGroup("obstacles", parts, DepthTest.DISABLE);
  private final InstanceGroup images = new InstanceGroup("images", parts, DepthTest.DISABLE);
  private final InstanceGroup shades = new InstanceGroup("shades", parts, DepthTest.DISABLE);
  private final InstanceGroup raised = new InstanceGroup("raised", parts, DepthTest.INHERIT);
  private final InstanceGroup drones = new InstanceGroup("drones", parts, DepthTest.DISABLE);
  private final InstanceGroup lamps = new InstanceGroup("lamps", parts, DepthTest.DISABLE);
  private final InstanceGroup discs = new InstanceGroup("discs", parts, DepthTest.DISABLE);
  private final InstanceGroup overlay = new InstanceGroup("overlay", parts, DepthTest.DISABLE);
  private final Map<LightBase, Color> roomLights = new LinkedHashMap<>();
  private double brightness = 1;
  private List<Instance> shownObstacles = List.of();

  SceneNodes() {
    setId("scene");
    setMouseTransparent(true);
    getTransforms().add(FxFrames.ofRoom());
    raised.setTranslateZ(DECAL_OFFSET);
    getChildren()
        .addAll(room, ground, obstacles, images, shades, raised, drones, lamps, discs, overlay);
    addLight(new AmbientLight(Color.WHITE), lamps, overlay);
    addRoomLight(new AmbientLight(Color.WHITE), room, ground, images, shades, raised, discs);
    addLights(Lights.ON_FURNITURE, obstacles);
    addLights(Lights.ON_DRONES, drones);
  }

  /**
   * Dims the lights in the room. Luminous parts and the visual aids keep their brightness. Does
   * nothing if the brightness is unchanged, because JavaFX redraws everything that a light
   * illuminates whenever the light is set, even to the same brightness.
   *
   * @param newBrightness the new brightness, 0 to 1
   */
  void dim(double newBrightness) {
    if (newBrightness == brightness) {
      return;
    }
    brightness = newBrightness;
    roomLights.forEach((light, color) -> light.setColor(color.deriveColor(0, 1, brightness, 1)));
  }

  /**
   * Shows a scene.
   *
   * @param camera the pose of the camera; drones that the camera cannot see are omitted
   */
  void show(Scene scene, Pose camera) {
    room.show(scene.room());
    ground.show(only(scene.ground(), decal -> !isRaised(decal)));
    raised.show(only(scene.ground(), SceneNodes::isRaised));
    if (scene.obstacles() != shownObstacles) {
      shownObstacles = scene.obstacles();
      List<Instance> batches =
          MeshBatch.of(shownObstacles).stream().map(Instance::atOrigin).toList();
      obstacles.show(with(batches, Shading.MATTE));
      images.show(with(batches, Shading.UNLIT));
      shades.show(with(batches, Shading.TRANSLUCENT));
    }
    drones.show(with(scene.drones(), Shading.GLOSSY));
    drones.cull(instance -> mayBeSeen(instance, camera));
    lamps.show(with(scene.drones(), Shading.UNLIT));
    discs.show(with(scene.drones(), Shading.TRANSLUCENT));
    overlay.show(scene.overlay());
  }

  private static List<Instance> with(List<Instance> instances, Shading shading) {
    return only(instances, instance -> instance.part().material().shading() == shading);
  }

  private static List<Instance> only(List<Instance> instances, Predicate<Instance> wanted) {
    return instances.stream().filter(wanted).toList();
  }

  /** Returns whether a decal lies on an obstacle and must therefore be drawn after it. */
  private static boolean isRaised(Instance decal) {
    return decal.part().material().shading() == Shading.DECAL
        && decal.pose().attitude().up().z() > 0.5
        && decal.pose().position().z() > 0;
  }

  /** Returns whether an object of a drone's size could be in the camera's view. */
  private static boolean mayBeSeen(Instance drone, Pose camera) {
    Vec3 way = drone.pose().position().minus(camera.position());
    double distance = way.norm();
    Vec3 ahead = camera.attitude().toRoom(new Vec3(1, 0, 0));
    return distance < NEARBY || way.dot(ahead) > WIDEST * distance;
  }

  private void addLights(Lights lights, InstanceGroup lit) {
    addRoomLight(new AmbientLight(FxTextures.color(lights.ambient())), lit);
    for (Lights.Directional light : lights.directional()) {
      DirectionalLight node = new DirectionalLight(FxTextures.color(light.color()));
      Vec3 direction = light.direction();
      node.setDirection(new Point3D(direction.x(), direction.y(), direction.z()));
      addRoomLight(node, lit);
    }
  }

  /** Adds a light that can be dimmed. */
  private void addRoomLight(LightBase light, InstanceGroup... lit) {
    roomLights.put(light, light.getColor());
    addLight(light, lit);
  }

  private void addLight(LightBase light, InstanceGroup... lit) {
    light.getScope().addAll(lit);
    getChildren().add(light);
  }
}
