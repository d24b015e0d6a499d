package tellosimulator.view.world;

import java.util.List;
import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.transform.Affine;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.pad.PadCards;
import tellosimulator.view.FxFrames;
import tellosimulator.view.FxSimulation;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Room;

/** The mission pads. Made anew when they or the room change. */
final class PadsView extends Group {

  private final PadCards cards = new PadCards();
  private final PartViews views = new PartViews();
  private List<MissionPad> pads = List.of();
  private Room room = Room.DEFAULT;

  PadsView(FxSimulation simulation) {
    setId("pads");
    simulation.arenaProperty().subscribe(this::show);
  }

  private void show(Arena arena) {
    if (!pads.equals(arena.pads()) || !room.equals(arena.room())) {
      pads = arena.pads();
      room = arena.room();
      getChildren().setAll(cards.placed(room, pads).stream().map(this::view).toList());
    }
  }

  private Node view(Placed placed) {
    Node view = views.of(placed.part());
    Affine place = new Affine();
    FxFrames.place(place, placed.pose());
    view.getTransforms().add(place);
    return view;
  }
}
