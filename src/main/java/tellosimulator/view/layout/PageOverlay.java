package tellosimulator.view.layout;

import atlantafx.base.controls.ModalPane;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import javafx.scene.Node;
import javafx.scene.layout.StackPane;
import tellosimulator.view.gallery.GalleryPane;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;

/**
 * The pages that lie over the window: help, about, the gallery, questions, what is wrong with a
 * scenario, and the palette of commands. Lies over everything else in the window's root, and is not
 * there while no page is open. Closed by Esc, by a click beside the page, or by the page's button.
 * For the JavaFX thread.
 */
public final class PageOverlay extends StackPane {

  private final ModalPane pane = new ModalPane();
  private final ViewContext context;
  private Optional<Node> focusedBefore = Optional.empty();

  public PageOverlay(ViewContext context) {
    this.context = context;
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  /** Opens the help, or closes it if it is open. */
  public void toggleHelp() {
    if (pane.isDisplay() && pane.getContent() instanceof HelpPage) {
      pane.hide(true);
    } else {
      HelpPage help = new HelpPage(context); // made only now, because the window shall open fast
      help.refresh();
      show(help);
    }
  }

  /** Opens the palette of commands, or closes it if it is open. */
  public void togglePalette(WindowCommands commands) {
    if (pane.isDisplay() && pane.getContent() instanceof CommandPalette) {
      pane.hide(true);
    } else if (!asks()) {
      CommandPalette palette =
          new CommandPalette(context.language(), commands, () -> pane.hide(true));
      open(palette, palette::field);
    }
  }

  void showAbout() {
    show(new AboutPage(context));
  }

  /**
   * Lets somebody choose what to fly in, or closes that page if it is open.
   *
   * @param chooseFile lets somebody choose a file, and opens it
   */
  public void toggleGallery(GalleryPane.Offer offer, Runnable chooseFile) {
    if (pane.isDisplay() && pane.getContent() instanceof GalleryPage) {
      pane.hide(true);
    } else {
      open(new GalleryPage(context, offer, chooseFile, this::close));
    }
  }

  private void close(Runnable then) {
    pane.hide(true);
    then.run();
  }

  /** Says what is wrong with a scenario. */
  public void show(List<Function<Language, String>> diagnostics) {
    show(new DiagnosticsPage(context, diagnostics));
  }

  /** Asks something. */
  public void ask(QuestionPage.Question question) {
    open(new QuestionPage(context, question, () -> pane.hide(true)));
  }

  /** Whether a question waits for an answer. */
  public boolean asks() {
    return pane.isDisplay() && pane.getContent() instanceof QuestionPage;
  }

  private void show(Page page) {
    page.defaultButton().setOnAction(pressed -> pane.hide(true));
    open(page);
  }

  private void open(Page page) {
    open(page, page::firstFocus);
  }

  private void open(Node page, Supplier<Node> focused) {
    if (!pane.isDisplay()) {
      focusedBefore = Optional.ofNullable(getScene().getFocusOwner());
    }
    pane.show(page);
    page.applyCss(); // or what a scroll pane holds would not be in the scene yet
    focused.get().requestFocus();
  }

  private void initializeSelf() {
    setId("page-overlay");
    setPickOnBounds(false);
  }

  private void initializeParts() {
    pane.setId("page-overlay-pane");
    pane.setInTransitionFactory(null);
    pane.setOutTransitionFactory(null);
  }

  private void layoutParts() {
    getChildren().add(pane);
  }

  private void setupEventHandlers() {
    pane.displayProperty()
        .addListener(
            (observed, before, shown) -> {
              if (!shown) {
                focusedBefore.ifPresent(Node::requestFocus);
              }
            });
  }

  private void setupBindings() {
    visibleProperty().bind(pane.displayProperty());
    context.pulse().onBeat(nanos -> refreshHelp());
  }

  /** Where the drone is to be reached changes when it is switched on. */
  private void refreshHelp() {
    if (pane.isDisplay() && pane.getContent() instanceof HelpPage help) {
      help.refresh();
    }
  }
}
