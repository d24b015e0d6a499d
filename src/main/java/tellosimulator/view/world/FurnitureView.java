package tellosimulator.view.world;

import java.util.List;
import javafx.scene.Group;
import javafx.scene.Node;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.furniture.Furniture;
import tellosimulator.scenery.furniture.Joined;
import tellosimulator.view.FxSimulation;
import tellosimulator.world.Arena;
import tellosimulator.world.Obstacle;

/**
 * The obstacles, in the room frame. Made anew when they change: what has the same picture is one
 * node, as each node costs more than its triangles do.
 */
final class FurnitureView extends Group {

  private final Furniture furniture = new Furniture();
  private final PartViews views = new PartViews();
  private final Group lit = new Group();
  private final Group pictured = new Group();
  private List<Obstacle> obstacles = List.of();

  FurnitureView(FxSimulation simulation) {
    setId("furniture");
    getChildren().addAll(lit, pictured);
    simulation.arenaProperty().subscribe(this::show);
  }

  /** On what lamps shine. */
  Node lit() {
    return lit;
  }

  /** What is as bright as its picture, whatever light falls on it. */
  Node pictured() {
    return pictured;
  }

  private void show(Arena arena) {
    if (!obstacles.equals(arena.obstacles())) {
      obstacles = arena.obstacles();
      List<Part> parts = Joined.parts(furniture.placed(obstacles));
      fill(lit, parts, Finish.MATT);
      fill(pictured, parts, Finish.PAINTED);
    }
  }

  private void fill(Group group, List<Part> parts, Finish finish) {
    group
        .getChildren()
        .setAll(parts.stream().filter(part -> part.finish() == finish).map(views::of).toList());
  }
}
