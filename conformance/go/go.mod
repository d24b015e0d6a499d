module conformance

go 1.20

require (
	github.com/SMerrony/tello v0.9.3
	gobot.io/x/gobot/v2 v2.3.0
)

require (
	github.com/gofrs/uuid v4.4.0+incompatible // indirect
	github.com/hashicorp/errwrap v1.1.0 // indirect
	github.com/hashicorp/go-multierror v1.1.1 // indirect
)
