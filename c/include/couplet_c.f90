! couplet for Fortran 2008: the functions of couplet_c.h, which says what they do, and a function that makes a text of C one of
! Fortran. A text that is given ends with a zero: "80deg" // c_null_char.
module couplet_c
  use, intrinsic :: iso_c_binding
  implicit none
  public

  integer(c_int), parameter :: couplet_proved = 0, couplet_open = 1, couplet_usage = 2, couplet_resource = 3, &
    couplet_fault = 4
  integer(c_int), parameter :: couplet_lower = -1, couplet_value = 0, couplet_upper = 1
  ! In verdict and in mode, which are integer(c_int8_t): 255 is -1 there.
  integer(c_int8_t), parameter :: couplet_stands = 0, couplet_falls = 1, couplet_undecided = 2, couplet_refused = 3, &
    couplet_no_mode = -1

  interface
    function couplet_state(weight, half_opening, friction, digits, answer) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: weight(*), half_opening(*), friction(*)
      integer(c_size_t), value :: digits
      type(c_ptr), intent(out) :: answer
      integer(c_int) :: code
    end function

    function couplet_assess(weight, half_opening, friction, thickness, digits, answer) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: weight(*), half_opening(*), friction(*), thickness(*)
      integer(c_size_t), value :: digits
      type(c_ptr), intent(out) :: answer
      integer(c_int) :: code
    end function

    function couplet_arch(weight, arch, digits, answer) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: weight(*), arch(*)
      integer(c_size_t), value :: digits
      type(c_ptr), intent(out) :: answer
      integer(c_int) :: code
    end function

    ! What is not given is c_null_ptr, and what is given c_loc of a target.
    function couplet_find(weight, modes, half_opening, friction, thickness, digits, answer) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: weight(*)
      type(c_ptr), value :: modes, half_opening, friction, thickness
      integer(c_size_t), value :: digits
      type(c_ptr), intent(out) :: answer
      integer(c_int) :: code
    end function

    function couplet_constant(landmark, weight, quantity, digits, threads, answer) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: landmark(*), weight(*), quantity(*)
      integer(c_size_t), value :: digits, threads
      type(c_ptr), intent(out) :: answer
      integer(c_int) :: code
    end function

    function couplet_certify_landmark(landmark, weight, digits, threads, answer) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: landmark(*), weight(*)
      integer(c_size_t), value :: digits, threads
      type(c_ptr), intent(out) :: answer
      integer(c_int) :: code
    end function

    function couplet_certify_arch(weight, half_opening, friction, thickness, digits, answer) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: weight(*), half_opening(*), friction(*)
      type(c_ptr), value :: thickness
      integer(c_size_t), value :: digits
      type(c_ptr), intent(out) :: answer
      integer(c_int) :: code
    end function

    function couplet_check(certificate, length, engine, answer) bind(c) result(code)
      import
      type(c_ptr), value :: certificate, engine
      integer(c_size_t), value :: length
      type(c_ptr), intent(out) :: answer
      integer(c_int) :: code
    end function

    ! values(n, 3, quantities): of each quantity the nearest doubles, the lower and the upper bounds. The thickness is
    ! c_null_ptr, or c_loc of an array.
    function couplet_states(weight, n, half_opening, friction, thickness, quantities, threads, verdict, mode, values, &
        answer) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: weight(*), quantities(*)
      integer(c_size_t), value :: n, threads
      real(c_double), intent(in) :: half_opening(*), friction(*)
      type(c_ptr), value :: thickness
      integer(c_int8_t), intent(out) :: verdict(*), mode(*)
      real(c_double), intent(out) :: values(*)
      type(c_ptr), intent(out) :: answer
      integer(c_int) :: code
    end function

    function couplet_verdict(answer) bind(c) result(text)
      import
      type(c_ptr), value :: answer
      type(c_ptr) :: text
    end function

    function couplet_reason(answer) bind(c) result(text)
      import
      type(c_ptr), value :: answer
      type(c_ptr) :: text
    end function

    function couplet_note(answer) bind(c) result(text)
      import
      type(c_ptr), value :: answer
      type(c_ptr) :: text
    end function

    function couplet_mode(answer) bind(c) result(text)
      import
      type(c_ptr), value :: answer
      type(c_ptr) :: text
    end function

    function couplet_count(answer) bind(c) result(count)
      import
      type(c_ptr), value :: answer
      integer(c_size_t) :: count
    end function

    function couplet_quantity(answer, index) bind(c) result(text)
      import
      type(c_ptr), value :: answer
      integer(c_size_t), value :: index
      type(c_ptr) :: text
    end function

    function couplet_text(answer, quantity, which) bind(c) result(text)
      import
      type(c_ptr), value :: answer
      character(kind=c_char), intent(in) :: quantity(*)
      integer(c_int), value :: which
      type(c_ptr) :: text
    end function

    function couplet_double(answer, quantity, value, lower, upper) bind(c) result(code)
      import
      type(c_ptr), value :: answer
      character(kind=c_char), intent(in) :: quantity(*)
      real(c_double), intent(out) :: value, lower, upper
      integer(c_int) :: code
    end function

    function couplet_json(answer) bind(c) result(text)
      import
      type(c_ptr), value :: answer
      type(c_ptr) :: text
    end function

    subroutine couplet_free(answer) bind(c)
      import
      type(c_ptr), value :: answer
    end subroutine

    function couplet_version() bind(c) result(text)
      import
      type(c_ptr) :: text
    end function

    function couplet_mode_name(code) bind(c) result(text)
      import
      integer(c_int), value :: code
      type(c_ptr) :: text
    end function

    function couplet_copy(text, buffer, size) bind(c) result(length)
      import
      type(c_ptr), value :: text
      character(kind=c_char), intent(out) :: buffer(*)
      integer(c_size_t), value :: size
      integer(c_size_t) :: length
    end function

    function couplet_exact(x, buffer, size) bind(c) result(length)
      import
      real(c_double), value :: x
      character(kind=c_char), intent(out) :: buffer(*)
      integer(c_size_t), value :: size
      integer(c_size_t) :: length
    end function
  end interface

contains

  ! The text of C that a function returned.
  function couplet_string(text) result(string)
    type(c_ptr), intent(in) :: text
    character(:), allocatable :: string
    character(kind=c_char) :: none(1)
    character(kind=c_char), allocatable :: buffer(:)
    integer(c_size_t) :: length, i
    length = couplet_copy(text, none, 0_c_size_t)
    allocate(buffer(length + 1))
    allocate(character(length) :: string)
    length = couplet_copy(text, buffer, length + 1)
    do i = 1, length
      string(i:i) = buffer(i)
    end do
  end function
end module
