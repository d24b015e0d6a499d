package tellosimulator.view.world;

import javafx.scene.Group;
import tellosimulator.scenery.room.Interior;
import tellosimulator.view.FxSimulation;

/** The room with all that is painted on it. Made anew when the room or its decor changes. */
final class RoomView extends Group {

  private final FxSimulation simulation;
  private final Interior interior = new Interior();
  private final PartViews views = new PartViews();

  RoomView(FxSimulation simulation) {
    this.simulation = simulation;
    setId("room");
    simulation.decorProperty().subscribe(decor -> build());
    simulation.roomProperty().addListener((property, before, room) -> build());
  }

  private void build() {
    getChildren()
        .setAll(
            interior
                .parts(simulation.roomProperty().get(), simulation.decorProperty().get())
                .stream()
                .map(views::of)
                .toList());
  }
}
