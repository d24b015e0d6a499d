package tellosimulator.view.app;

import java.util.Objects;
import javafx.scene.image.Image;
import javafx.stage.Stage;

/** The program's icon in task bars and windows. The source of the image is packaging/icon.svg. */
final class AppIcon {

  private static final String FILE = "icon.png";

  private AppIcon() {}

  /** Sets the icon of a window. */
  static void show(Stage stage) {
    String address = Objects.requireNonNull(AppIcon.class.getResource(FILE)).toExternalForm();
    stage.getIcons().add(new Image(address));
  }
}
