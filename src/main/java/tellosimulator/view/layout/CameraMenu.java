package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.StringBinding;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.ToggleGroup;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Messages;
import tellosimulator.view.world.RoomView;
import tellosimulator.view.world.Simulator3DScene;
import tellosimulator.view.world.ViewCamera;

/**
 * From where one looks: a button with the name of the view, and a menu of all of them with their
 * keys. For the JavaFX thread.
 */
final class CameraMenu extends MenuButton {

  /** The texts of a hand's own view and of the drone's camera. */
  private static final String OWN = "view-own";

  private static final String DRONE = "view-drone";

  private static final Map<RoomView, WindowKey> KEYS =
      new EnumMap<>(
          Map.of(
              RoomView.START, WindowKey.START_VIEW,
              RoomView.FRONT, WindowKey.FRONT_VIEW,
              RoomView.SIDE, WindowKey.SIDE_VIEW,
              RoomView.TOP, WindowKey.TOP_VIEW,
              RoomView.CHASE, WindowKey.CHASE_VIEW));

  private final Messages messages;
  private final Simulator3DScene scene;
  private final ReadOnlyObjectProperty<Optional<RoomView>> view;
  private final ToggleGroup views = new ToggleGroup();

  CameraMenu(Messages messages, Simulator3DScene scene) {
    super("", new FontIcon(Feather.VIDEO));
    this.messages = messages;
    this.scene = scene;
    this.view = scene.camera().viewProperty();
    setId("camera");
    getStyleClass().addAll(Styles.FLAT, Styles.SMALL);
    Tooltips.install(this, messages.text("camera-tip"));
    StringBinding name = messages.text(OWN);
    textProperty()
        .bind(
            Bindings.createStringBinding(
                () -> messages.now(shownKey()), name, view, scene.viewCameraProperty()));
    accessibleTextProperty().bind(messages.text("camera-accessible", textProperty()));
    for (RoomView each : RoomView.values()) {
      add(key(each), KEYS.get(each), () -> scene.look(each));
    }
    add(DRONE, WindowKey.DRONE_CAMERA, () -> scene.viewCameraProperty().set(ViewCamera.DRONE));
    MenuItem fit = named(new MenuItem(), "menu-fit", WindowKey.FIT);
    fit.setOnAction(event -> scene.fit());
    CheckMenuItem follow = named(new CheckMenuItem(), "menu-follow", WindowKey.FOLLOW);
    follow.selectedProperty().bindBidirectional(scene.camera().followingProperty());
    getItems().addAll(new SeparatorMenuItem(), fit, follow);
    view.subscribe(this::mark);
    scene.viewCameraProperty().subscribe(this::mark);
  }

  private void add(String key, WindowKey shortcut, Runnable action) {
    RadioMenuItem item = named(new RadioMenuItem(), key, shortcut);
    item.setToggleGroup(views);
    item.setOnAction(
        event -> {
          action.run();
          mark();
        });
    getItems().add(item);
  }

  private <I extends MenuItem> I named(I item, String key, WindowKey shortcut) {
    item.setId(key);
    StringBinding name = messages.text(key);
    item.textProperty()
        .bind(
            Bindings.createStringBinding(
                () -> messages.now("menu-key", name.get(), shortcut.symbol(messages)), name));
    return item;
  }

  /** Marks what is seen; nothing while a hand's own view is. */
  private void mark() {
    String shown = shownKey();
    views.selectToggle(
        views.getToggles().stream()
            .filter(item -> shown.equals(((MenuItem) item).getId()))
            .findFirst()
            .orElse(null));
  }

  private String shownKey() {
    return scene.viewCameraProperty().get() == ViewCamera.DRONE
        ? DRONE
        : view.get().map(CameraMenu::key).orElse(OWN);
  }

  private static String key(RoomView view) {
    return "view-" + view.name().toLowerCase(Locale.ROOT);
  }
}
