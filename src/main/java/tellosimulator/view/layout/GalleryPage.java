package tellosimulator.view.layout;

import java.util.function.Consumer;
import javafx.scene.Node;
import javafx.scene.control.Button;
import tellosimulator.view.gallery.GalleryPane;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/** Lets somebody choose what to fly in. For the JavaFX thread. */
final class GalleryPage extends Page {

  private final GalleryPane gallery;

  /**
   * @param chooseFile lets somebody choose a file, and opens it
   * @param close lets go of the page, and then does something
   */
  GalleryPage(
      ViewContext context, GalleryPane.Offer offer, Runnable chooseFile, Consumer<Runnable> close) {
    super(
        "gallery-page",
        "gallery-page",
        context.language().messages(GalleryPage.class).text("gallery"));
    Messages messages = context.language().messages(GalleryPage.class);
    ScenarioActions actions = context.scenario().actions();
    gallery =
        new GalleryPane(
            context.language(),
            offer,
            new GalleryPane.OptionValue(
                name -> close.accept(() -> actions.openKnown(name)),
                file -> close.accept(() -> actions.open(file))));
    setMaxHeight(USE_PREF_SIZE);
    Button open = addButton("gallery-open", messages.text("gallery-open"));
    open.setDefaultButton(false); // what one comes for are the cards
    open.setOnAction(pressed -> close.accept(chooseFile));
    addButton("gallery-empty", messages.text("gallery-empty"))
        .setOnAction(pressed -> close.accept(actions::openEmpty));
    addButton("gallery-close", messages.text("close"))
        .setOnAction(pressed -> close.accept(() -> {}));
    layoutPage(messages.label("gallery-hint", "muted"), gallery);
  }

  @Override
  Node firstFocus() {
    return gallery.firstCard();
  }
}
