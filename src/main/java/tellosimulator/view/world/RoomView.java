package tellosimulator.view.world;

import javafx.geometry.Rectangle2D;
import javafx.scene.DepthTest;
import javafx.scene.Group;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.MeshView;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.view.FxSimulation;
import tellosimulator.view.world.Quads.Quad;
import tellosimulator.world.Room;

/**
 * The room: a floor with a grid and metre marks, walls and a ceiling. Walls and ceiling have only
 * an inside: where they stand between the camera and the room they are not drawn. Made anew when
 * the room or the grid changes.
 */
final class RoomView extends Group {

  /** Brightness of the walls across the depth; so one sees the corners. Decided: by eye. */
  private static final double SHADE = 0.955;

  private final FxSimulation simulation;
  private final MeshView floor = surface("floor");
  private final MeshView frontAndBack = surface("walls-across");
  private final MeshView sides = surface("walls-along");
  private final MeshView marks = surface("metre-marks");
  private double wallHeight;

  RoomView(FxSimulation simulation) {
    this.simulation = simulation;
    initializeSelf();
    initializeParts();
    layoutParts();
    setupBindings();
  }

  private void initializeSelf() {
    setId("room");
  }

  private void initializeParts() {
    material(marks).setDiffuseMap(MetreMarks.picture());
    marks.setDepthTest(DepthTest.DISABLE);
  }

  private void layoutParts() {
    getChildren().addAll(floor, frontAndBack, sides, marks);
  }

  private void setupBindings() {
    simulation
        .gridCmProperty()
        .subscribe(
            gridCm -> {
              double grid = Frames.metres(gridCm.doubleValue());
              material(floor).setDiffuseMap(Pictures.floorTile(grid));
              layFloor(simulation.roomProperty().get(), grid);
            });
    simulation.roomProperty().subscribe(this::build);
  }

  private void build(Room room) {
    layFloor(room, Frames.metres(simulation.gridCmProperty().get()));
    buildWalls(room);
    marks.setMesh(MetreMarks.mesh(room));
    if (wallHeight != room.height()) {
      wallHeight = room.height();
      material(frontAndBack).setDiffuseMap(Pictures.wall(wallHeight, 1));
      material(sides).setDiffuseMap(Pictures.wall(wallHeight, SHADE));
    }
  }

  /** The lines go through the origin of the room frame, which is in the middle of a tile. */
  private void layFloor(Room room, double grid) {
    double right = room.width() / grid;
    double up = room.depth() / grid;
    Quad quad =
        new Quad(
            new Vec3(-room.depth() / 2, room.width() / 2, 0),
            new Vec3(0, -room.width(), 0),
            new Vec3(room.depth(), 0, 0));
    Rectangle2D tiles = new Rectangle2D(0, 0, right, up);
    floor.setMesh(new Quads().add(quad, centred(tiles)).mesh());
  }

  /** Such that the middle of the rectangle is in the middle of a tile. */
  private static Rectangle2D centred(Rectangle2D tiles) {
    double x = 0.5 - tiles.getWidth() / 2;
    double y = 0.5 - tiles.getHeight() / 2;
    double whole = Math.ceil(Math.max(-x, -y)); // a Rectangle2D may begin anywhere, but be tidy
    return new Rectangle2D(x + whole, y + whole, tiles.getWidth(), tiles.getHeight());
  }

  private void buildWalls(Room room) {
    Vec3 up = Vec3.UP.times(room.height());
    Vec3 depth = new Vec3(room.depth(), 0, 0);
    Vec3 width = new Vec3(0, room.width(), 0);
    Vec3 backRight = depth.plus(width).times(-0.5);
    Vec3 frontLeft = depth.plus(width).times(0.5);
    Rectangle2D strip = Quads.WHOLE;
    frontAndBack.setMesh(
        new Quads()
            .add(new Quad(frontLeft, width.times(-1), up), strip)
            .add(new Quad(backRight, width, up), strip)
            .add(ceiling(backRight.plus(up), depth, width), new Rectangle2D(0, 0, 1, 0.001))
            .mesh());
    sides.setMesh(
        new Quads()
            .add(new Quad(backRight.plus(width), depth, up), strip)
            .add(new Quad(frontLeft.minus(width), depth.times(-1), up), strip)
            .mesh());
  }

  /** Seen from below. */
  private static Quad ceiling(Vec3 corner, Vec3 depth, Vec3 width) {
    return new Quad(corner, width, depth);
  }

  private static MeshView surface(String id) {
    MeshView view = new MeshView();
    view.setId(id);
    view.setMaterial(new PhongMaterial());
    return view;
  }

  private static PhongMaterial material(MeshView view) {
    return (PhongMaterial) view.getMaterial();
  }
}
