package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.List;
import javafx.geometry.Point3D;
import javafx.scene.AmbientLight;
import javafx.scene.DirectionalLight;
import javafx.scene.Group;
import javafx.scene.LightBase;
import javafx.scene.Node;
import javafx.scene.paint.Color;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Lamps;
import tellosimulator.scenery.Lamps.Lamp;
import tellosimulator.scenery.room.Underneath;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxFrames;
import tellosimulator.view.FxSimulation;
import tellosimulator.view.FxTextures;
import tellosimulator.view.drone.DroneView;

/**
 * Everything in the room, in the room frame. Its order is that of drawing: floor and walls, what
 * lies on them, obstacles, drones, and last what one sees through.
 */
final class World extends Group {

  /** What one drone adds. */
  private record Parts(
      DroneView view, Trail trail, PlumbLine plumbLine, List<NumberTag> tags, FollowsStart start) {}

  /** Drones that are nearer than this are always drawn [m]. Decided: some times their size. */
  private static final double NEARBY = 1;

  /** Cosine of the widest angle from the middle of a picture. Decided: beyond any window's form. */
  private static final double WIDEST = Math.cos(Math.toRadians(58));

  private final FxSimulation simulation;
  private final List<Parts> drones = new ArrayList<>();
  private final RoomView room;
  private final PadsView pads;
  private final FurnitureView furniture;
  private final Group marks = new Group();
  private final Group raised = new Group();
  private final Group bodies = new Group();
  private final Group trails = new Group();
  private final Group aids = new Group();

  World(FxSimulation simulation) {
    this.simulation = simulation;
    room = new RoomView(simulation);
    pads = new PadsView(simulation);
    furniture = new FurnitureView(simulation);
    initializeSelf();
    initializeParts();
    layoutParts();
  }

  /**
   * Moves on with the drones.
   *
   * @param nanos the time of the picture [ns]
   * @param camera through which one sees it
   */
  void advance(long nanos, Pose camera) {
    for (Parts drone : drones) {
      drone.view.advance();
      if (!mayBeSeen(drone.view.position(), camera)) {
        drone.view.setVisible(false); // the toolkit would take its thousands of corners on
      }
      if (drone.start.wasReset()) {
        drone.trail.clear();
      }
      drone.trail.advance(nanos);
      drone.plumbLine.advance(camera.position());
      drone.tags.forEach(tag -> tag.advance(camera));
    }
  }

  /** Whether something as large as a drone could be in the picture of a camera. */
  private static boolean mayBeSeen(Vec3 place, Pose camera) {
    Vec3 way = place.minus(camera.position());
    double distance = way.norm();
    Vec3 ahead = camera.attitude().toRoom(new Vec3(1, 0, 0));
    return distance < NEARBY || way.dot(ahead) > WIDEST * distance;
  }

  /** The flown paths. */
  Node trails() {
    return trails;
  }

  /** Shows what is in the room, and what helps people to see where drones are. */
  void showForPeople() {
    aids.setVisible(true);
    drones.forEach(drone -> drone.view.setVisible(true));
  }

  /**
   * Shows only what a drone's camera sees, in which the drone is not itself.
   *
   * @param number that of the drone, from 1
   */
  void showForDrone(int number) {
    aids.setVisible(false);
    for (int i = 0; i < drones.size(); i++) {
      drones.get(i).view.setVisible(simulation.drones().get(i).number() != number);
    }
  }

  private void initializeSelf() {
    setId("world");
    setMouseTransparent(true);
    getTransforms().add(FxFrames.ofRoom());
  }

  private void initializeParts() {
    Underneath underneath = new Underneath();
    boolean several = simulation.drones().size() > 1;
    for (FxDroneModel drone : simulation.drones()) {
      List<NumberTag> tags = several ? List.of(new NumberTag(drone)) : List.of();
      drones.add(
          new Parts(
              new DroneView(drone),
              new Trail(drone),
              new PlumbLine(drone),
              tags,
              new FollowsStart(drone)));
      GroundMarks left = new GroundMarks(drone, simulation, underneath);
      marks.getChildren().add(left);
      raised.getChildren().add(left.onObstacle());
    }
  }

  private void layoutParts() {
    for (Parts drone : drones) {
      bodies.getChildren().add(drone.view);
      trails.getChildren().add(drone.trail);
      aids.getChildren().add(drone.plumbLine);
      aids.getChildren().addAll(drone.tags);
    }
    aids.getChildren().add(trails);
    getChildren().addAll(room, pads, marks, furniture, raised, bodies, aids);
  }

  /**
   * Lights that shine as those of the world do; made anew with each call. Most things have their
   * light in their pictures, which is cheaper.
   */
  Group lights() {
    AmbientLight asPainted = new AmbientLight(Color.WHITE);
    asPainted.getScope().addAll(room, pads, marks, raised, furniture.pictured(), aids);
    drones.forEach(drone -> asPainted.getScope().add(drone.view.lamp()));
    Group lights = new Group(asPainted);
    lights.getChildren().addAll(lights(Lamps.ON_DRONES, bodies));
    lights.getChildren().addAll(lights(Lamps.ON_FURNITURE, furniture.lit()));
    lights.getTransforms().add(FxFrames.ofRoom());
    return lights;
  }

  private static List<LightBase> lights(Lamps lamps, Node on) {
    List<LightBase> lights = new ArrayList<>();
    lights.add(new AmbientLight(FxTextures.color(lamps.ambient())));
    lamps.all().forEach(lamp -> lights.add(directional(lamp)));
    lights.forEach(light -> light.getScope().add(on));
    return lights;
  }

  private static DirectionalLight directional(Lamp lamp) {
    DirectionalLight light = new DirectionalLight(FxTextures.color(lamp.color()));
    Vec3 direction = lamp.direction();
    light.setDirection(new Point3D(direction.x(), direction.y(), direction.z()));
    return light;
  }
}
